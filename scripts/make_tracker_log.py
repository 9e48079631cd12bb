#!/usr/bin/python3
"""Writes configs/logs/tracker_small.csv: a hand presses down and lifts again, seen by an optical tracker.

Made, not recorded, in the shape of an NDI tracker's table: frame numbers at 60 Hz that start anywhere,
a column that says whether the tool was seen, a unit quaternion (Q0 real), millimetres in the camera's
frame (x down to the table is -x, z away from the camera is negative) and the fit's error. Where the tool
is not seen a number stands that no pose has, -3.697314E28: in three rows that say so and in one that does
not. One frame is missing. The same file on every run.

    scripts/make_tracker_log.py > configs/logs/tracker_small.csv
"""

FIRST_FRAME, FRAMES, RATE_HZ = 48211, 62, 60
REST_MM = (120.0, -5.0, -1000.0)
MISSING = "-3.697314E28"
NOT_SEEN = {20, 21, 22}  # frames, from the first
SEEN_WITHOUT_A_POSE = 30
ABSENT = 40


def depth_mm(time_s):
    """Down by 14 mm in 0.4 s, held for 0.2 s, up again in 0.4 s; minimum jerk."""
    share = min(time_s / 0.4, 1.0) if time_s < 0.6 else max(1 - (time_s - 0.6) / 0.4, 0.0)
    return 14.0 * share**3 * (10 - 15 * share + 6 * share * share)


def main():
    print("Tools,Frame,State,Q0,Qx,Qy,Qz,Tx,Ty,Tz,Error")
    for frame in range(FRAMES):
        if frame == ABSENT:
            continue
        x, y, z = REST_MM
        pose = [f"{1:.5f}", *[f"{0:.5f}"] * 3, f"{x - depth_mm(frame / RATE_HZ):.3f}", f"{y:.3f}", f"{z:.3f}"]
        if frame in NOT_SEEN or frame == SEEN_WITHOUT_A_POSE:
            pose = [MISSING] * 7
        state, error = ("Missing", MISSING) if frame in NOT_SEEN else ("OK", "0.1250")
        print(",".join(["1", str(FIRST_FRAME + frame), state, *pose, error]))


if __name__ == "__main__":
    main()
