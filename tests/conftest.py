"""Lets the Python tests import what they share, as host.fake_unit, wherever pytest is started."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
