#!/usr/bin/python3
"""Writes configs/logs/falcon_small.csv, a hand presses down 35 mm and comes back, or with the word clamp
configs/logs/falcon_clamp.csv: it comes down by 40 mm, closes a clamp by a push of 12 mm, lifts it and holds.

Made, not recorded, in the shape of a Falcon's log: positions in metres in libnifalcon's frame (x
right, y up, z from the base to the operator), 100 Hz, with the force of a spring of 60 N/m that
pulls the grip back to where it started (for looking at; a replay reads positions only). As in real
sessions the device freezes: stretches of rows repeat the row before them, and the first row after
one has caught up with the hand in one step. The same file on every run.

    scripts/make_falcon_log.py > configs/logs/falcon_small.csv
    scripts/make_falcon_log.py clamp > configs/logs/falcon_clamp.csv
"""
import math
import sys

RATE_HZ = 100
REST_M = (0.0015, 0.0175, 0.105)
DEPTH_M = 0.035
REACH_M, PUSH_M, LIFT_M = 0.040, 0.012, 0.045  # of the clamp: down, to close, and up again
SPRING_N_M = 60.0
FROZEN_ROWS = [(38, 44), (95, 120), (160, 163)]  # first and last repeated row of each stretch
ROWS = 201


def smooth(u):
    """Minimum jerk from 0 to 1."""
    u = min(max(u, 0.0), 1.0)
    return u**3 * (10 - 15 * u + 6 * u * u)


def pressed(time_s):
    """Share of the depth: rest, a reach of 0.7 s, a pause, a return of 0.6 s, rest."""
    if time_s < 1.2:
        u, there = (time_s - 0.1) / 0.7, True
    else:
        u, there = (time_s - 1.25) / 0.6, False
    return smooth(u) if there else 1 - smooth(u)


def pressing_hand_m(time_s):
    """The press with a drift to the side and a tremor of 0.15 mm at 9 Hz."""
    share = pressed(time_s)
    tremor_m = 0.00015 * math.sin(2 * math.pi * 9 * time_s)
    return (
        REST_M[0] + 0.0012 * share + 0.5 * tremor_m,
        REST_M[1] - DEPTH_M * share + tremor_m,
        REST_M[2] - 0.0020 * share * share + 0.3 * tremor_m,
    )


def clamping_hand_m(time_s):
    """Down, away from the operator, which closes, and up; with a drift and the same tremor."""
    down, closed, up = (smooth((time_s - start_s) / 0.5) for start_s in (0.1, 0.65, 1.2))
    tremor_m = 0.00015 * math.sin(2 * math.pi * 9 * time_s)
    return (
        REST_M[0] + 0.0010 * up + 0.5 * tremor_m,
        REST_M[1] - REACH_M * down + LIFT_M * up + tremor_m,
        REST_M[2] + 0.0015 * down - PUSH_M * closed + 0.3 * tremor_m,
    )


def main():
    hand_m = clamping_hand_m if sys.argv[1:] == ["clamp"] else pressing_hand_m
    print("t_s_nominal100Hz,x_m,y_m,z_m,fx_cmd_N,fy_cmd_N,fz_cmd_N")
    position_m = hand_m(0)
    for row in range(ROWS):
        if not any(first <= row <= last for first, last in FROZEN_ROWS):
            position_m = tuple(round(value, 7) for value in hand_m(row / RATE_HZ))
        force_N = [SPRING_N_M * (rest - here) for rest, here in zip(REST_M, position_m)]
        cells = [f"{row / RATE_HZ:.2f}"]
        cells += [f"{value:.7f}" for value in position_m]
        cells += [f"{value:.6f}" for value in force_N]
        print(",".join(cells))


if __name__ == "__main__":
    main()
