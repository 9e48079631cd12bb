#!/usr/bin/python3
"""Writes configs/logs/palpation_small.csv: a robot's arm palpates with 2 Hz, six times, drifting aside.

Made, not recorded, in the shape of the logs of robot-palpation-data (Vanderbilt, CMU, JHU): seconds that do
not start at zero, millimetres (z up, -120 at rest), the force in newtons of a tissue of 150 N/m below z =
-124 mm (for looking at; a replay reads poses only), a unit quaternion (q0 real) that tilts by up to 3 degrees.
Steps of 14 to 19 ms, one of 120 ms, one of about 0.3 s, longer than a replay bridges by default, and a row
without a pose. The same file on every run.

    scripts/make_palpation_log.py > configs/logs/palpation_small.csv
"""
import math

START_S, END_S = 0.0283, 3.4
REST_MM = (-6.4628, -12.7021, -120.0)
TOUCH_Z_MM = -124.0
STIFFNESS_N_MM = 0.15
LONG_STEPS_S = {60: 0.120, 140: 0.304}  # row: time until the next one
ROW_WITHOUT_POSE = 100
HELD = (0.0, -math.sqrt(0.5), math.sqrt(0.5), 0.0)  # q0..q3: how the arm holds its probe


def multiply(a, b):
    return (
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    )


def pose(time_s):
    """Down by 7 mm in 0.3 s, then 3 mm up and down about it with 2 Hz for 2.75 s, then up again."""
    palpating_s = min(max(time_s - 0.3, 0.0), 2.75)
    share = min(time_s / 0.3, 1.0) if time_s < 3.05 else max(1 - (time_s - 3.05) / 0.25, 0.0)
    share = share**3 * (10 - 15 * share + 6 * share * share)
    depth_mm = 7.0 * share + 3.0 * math.sin(4 * math.pi * palpating_s) * math.sin(math.pi * palpating_s / 2.75)
    x_mm = REST_MM[0] + 1.2 * palpating_s + 0.05 * math.sin(17.0 * time_s)
    y_mm = REST_MM[1] + 0.4 * math.sin(2.1 * time_s)
    half_rad = math.radians(1.5) * math.sin(2 * math.pi * 0.7 * time_s) * share
    tilt = (math.cos(half_rad), math.sin(half_rad), 0.0, 0.0)
    return (x_mm, y_mm, REST_MM[2] - depth_mm), multiply(tilt, HELD)


def main():
    print("t_s,x_mm,y_mm,z_mm,fx_N,fy_N,fz_N,q0,q1,q2,q3")
    time_s, row, noise = START_S, 0, 1
    while time_s < END_S:
        (x, y, z), quaternion = pose(time_s - START_S)
        pressed_N = STIFFNESS_N_MM * max(TOUCH_Z_MM - z, 0.0)
        cells = [f"{time_s:.5f}", f"{x:.4f}", f"{y:.4f}", f"{z:.4f}", "0.00000", "0.00000", f"{pressed_N:.5f}"]
        cells += [f"{value:.6f}" for value in quaternion] if row != ROW_WITHOUT_POSE else [""] * 4
        print(",".join(cells))
        noise = (1103515245 * noise + 12345) % 2**31
        time_s += LONG_STEPS_S.get(row, 0.014 + 0.005 * (noise / 2**31) ** 3)
        row += 1


if __name__ == "__main__":
    main()
