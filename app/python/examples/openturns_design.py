"""How much of the scatter of friction comes from which parameter: a design and Sobol' indices by
OpenTURNS. The whole design is one call.
"""

import numpy as np
import openturns as ot

import asperity

KEYS = ("load.normal_force", "elastomer.shear_modulus", "surface.rms_height")
scene = asperity.Scene(surface={"elements": 1000}, ensemble={"realizations": 4})
middle = [scene[key] for key in KEYS]
inputs = ot.ComposedDistribution([ot.LogUniform(np.log(m / 2), np.log(m * 2)) for m in middle])
inputs.setDescription(KEYS)


def log_friction(design):
    """ln mu of shape (n, 1) for a design of shape (n, 3)."""
    table = asperity.friction(scene, dict(zip(KEYS, np.array(design).T)))
    values = np.log(table.mu)
    return (values - values.mean())[:, np.newaxis]  # the indices are more exact about the mean


SIZE = 400
ot.RandomGenerator.SetSeed(1)
design = ot.SobolIndicesExperiment(inputs, SIZE).generate()
sobol = ot.SaltelliSensitivityAlgorithm(design, ot.Sample(log_friction(design)), SIZE)
for key, first, total in zip(KEYS, sobol.getFirstOrderIndices(), sobol.getTotalOrderIndices()):
    print(f"{key}: first order {first:.2f}, total {total:.2f}")
