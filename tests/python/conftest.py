"""What the tests share."""

import os
from pathlib import Path

import pytest

import asv

# Programs that tests start from other folders import the same module.
os.environ["PYTHONPATH"] = str(Path(asv.__file__).resolve().parents[1])

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def testcases():
    """The folder of the test cases."""
    return ROOT / "testcases"


@pytest.fixture
def past_a_box():
    """Three ASVs past a box: solved in no time."""
    return asv.Problem(start=[(0.10, 0.50), (0.15, 0.50), (0.15, 0.55)],
                       goal=[(0.80, 0.50), (0.85, 0.50), (0.85, 0.55)],
                       obstacles=[(0.40, 0.30, 0.60, 0.80)])
