#!/usr/bin/python3
"""Writes configs/curves/probe_presses.csv: a probe pressed three times into something like liver, 1, 2 and 3 mm.

Made, not measured: F = F0 + k d^n + lambda d^n d' with k = 6.08e5 N/m^n and n = 2.4 (pig liver in `fissure
list`), lambda/k = 0.5 s/m, F0 = 0.029 N, where the depth begins as in probing by contact force. Each press is
a squared sine of 60 ms, sampled every 2 ms; noise of 0.01 N. The same file on every run.

    scripts/make_probe_curve.py > configs/curves/probe_presses.csv
"""
import math

K, N, LAMBDA, F0_N = 6.08e5, 2.4, 3.04e5, 0.029
DEPTHS_M, PRESS_S, STEP_S, NOISE_N = (0.001, 0.002, 0.003), 0.06, 0.002, 0.01


def main():
    print("# Made by scripts/make_probe_curve.py, not measured.")
    print("time_ms,depth_mm,force_N")
    random = 1
    for i in range(round(len(DEPTHS_M) * PRESS_S / STEP_S) + 1):
        time_s = i * STEP_S
        deepest_m = DEPTHS_M[min(int(time_s / PRESS_S + 1e-9), len(DEPTHS_M) - 1)]
        angle = math.pi * time_s / PRESS_S
        depth_m = deepest_m * math.sin(angle) ** 2
        rate_m_s = deepest_m * math.sin(2 * angle) * math.pi / PRESS_S
        noise = -6.0  # twelve even numbers between 0 and 1 are nearly normal
        for _ in range(12):
            random = (1103515245 * random + 12345) % 2**31
            noise += random / 2**31
        force_N = F0_N + (K + LAMBDA * rate_m_s) * depth_m**N + NOISE_N * noise
        print(f"{1000 * time_s:.0f},{1000 * depth_m:.3f},{force_N:.3f}")


if __name__ == "__main__":
    main()
