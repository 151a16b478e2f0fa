#!/usr/bin/env python3
"""Writes persson_half_space.csv: Persson's theory of rubber friction by plain quadrature.

J. Chem. Phys. 115, 3840 (2001), with the prefactors and the correction S of measured friction that
core/friction/theories.h names. Nothing here is shared with the program: the
spectrum is a function of q instead of a list of waves, the integral over the direction is a sum
over 720 directions instead of a closed form, g(q) is integrated along ln q by the midpoint rule.
"""
import math

H, HEIGHT = 0.8, 5e-6  # Hurst exponent; rms height, m
Q_LOW, Q_ROLL, Q_HIGH = 2e3, 1.5e4, 6e5  # 1/m
G_INF, ARMS = 1e6, [(4e6, 1e-2), (2e7, 1e-4)]  # Pa; (Pa, s)
STEPS, DIRECTIONS = 3000, 720


def shape(q):
    """C_line up to a factor: constant up to the roll-off, then self-affine."""
    return 1.0 if q < Q_ROLL else (q / Q_ROLL) ** (-1 - 2 * H)


def modulus(w):
    return G_INF + sum(g * 1j * w * tau / (1 + 1j * w * tau) for g, tau in ARMS)


def logarithmic_steps():
    ratio = math.log(Q_HIGH / Q_LOW) / STEPS
    for i in range(STEPS):
        q = Q_LOW * math.exp((i + 0.5) * ratio)
        yield q, q * ratio


FACTOR = HEIGHT**2 / sum(2 * shape(q) * dq for q, dq in logarithmic_steps())


def around(w):
    """Integrals over the direction of cos(phi) Im G* and of |G*|^2."""
    loss = squared = 0.0
    for i in range(DIRECTIONS // 4):  # a quarter stands for all four
        c = math.cos(2 * math.pi * (i + 0.5) / DIRECTIONS)
        g = modulus(w * c)
        loss += 4 * c * g.imag
        squared += 4 * abs(g) ** 2
    step = 2 * math.pi / DIRECTIONS
    return loss * step, squared * step


def theory(velocity, pressure):
    g = friction = 0.0
    for q, dq in logarithmic_steps():
        c2 = FACTOR * shape(q) / (math.pi * q)
        loss, squared = around(q * velocity)
        step = q**3 * c2 * dq * squared * (4 / pressure) ** 2 / 8
        p = math.erf(1 / (2 * math.sqrt(g + step / 2)))
        g += step
        s = 0.5 + 0.5 * p * p
        friction += 0.5 * q**3 * c2 * dq * s * p * loss * 4 / pressure
    return friction, math.erf(1 / (2 * math.sqrt(g)))


print("velocity,nominal_pressure,mu,contact_fraction")
for pressure in (1e4, 1e6):
    for velocity in (1e-5, 1e-3, 1e-1, 1e1):
        mu, contact = theory(velocity, pressure)
        print(f"{velocity:g},{pressure:g},{mu:.8g},{contact:.8g}")
