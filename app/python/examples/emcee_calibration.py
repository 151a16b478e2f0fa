"""Calibrates modulus and relaxation time of a rubber by measured friction, with the sampler emcee.

All walkers of a step are one call: their states run side by side on the same random lines.
"""

import emcee
import numpy as np

import asperity

KEYS = ("elastomer.shear_modulus", "elastomer.relaxation_time")
scene = asperity.Scene(surface={"elements": 1000}, ensemble={"realizations": 4})

# Measured friction: here that of a rubber of 8 MPa and 2 ms, with 5 % of scatter.
velocities = np.geomspace(1e-2, 1e2, 9)[:, np.newaxis]
truth = np.log([8e6, 2e-3])


def friction_of(places):
    """mu of shape (velocities, walkers) for logarithms of the parameters, shape (walkers, 2)."""
    overrides = {key: np.exp(places[:, k]) for k, key in enumerate(KEYS)}
    return asperity.friction(scene, {"sliding.velocity": velocities, **overrides}).mu


random = np.random.RandomState(1)
measured = friction_of(truth[np.newaxis]) * np.exp(0.05 * random.standard_normal(velocities.shape))


def log_probability(places):
    return -0.5 * np.sum((np.log(friction_of(places) / measured) / 0.05) ** 2, axis=0)


start = truth + 0.3 * random.standard_normal((8, 2))
sampler = emcee.EnsembleSampler(8, 2, log_probability, vectorize=True)
sampler.random_state = random.get_state()  # the same samples each time
sampler.run_mcmc(start, 60)
samples = np.exp(sampler.get_chain(discard=20, flat=True))
for key, a, b, c in zip(KEYS, *np.percentile(samples, [16, 50, 84], axis=0)):
    print(f"{key}: {b:.3g} ({a:.3g} to {c:.3g})")
