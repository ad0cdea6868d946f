"""The chapter's own function."""

import numpy as np
import pytest
from book.beacon.functions import range_and_bearing


@pytest.mark.parametrize("turn", [-3.0, 0.0, 2.0])
def test_a_turn_of_the_robot_takes_the_bearing_back(turn):
    distance, bearing = range_and_bearing([0, 0, turn], [3, 4])
    assert distance == 5
    assert np.isclose(np.exp(1j * (bearing + turn)), np.exp(1j * np.arctan2(4, 3)))
