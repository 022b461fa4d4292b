"""Runs every test of this folder and prints one line that says how it went."""

import sys
import unittest
from pathlib import Path


def name_of(test: unittest.TestCase) -> str:
    """Of the test that a sub-test belongs to."""
    return str(getattr(test, "test_case", test))


def summary(result: unittest.TestResult) -> str:
    """A test with several failed sub-tests counts once; a class that cannot be set up counts as a failed test."""
    failed = len({name_of(test) for test, _ in (*result.failures, *result.errors)})
    passed = max(result.testsRun - failed - len(result.skipped), 0)
    skipped = f", {len(result.skipped)} skipped" if result.skipped else ""
    return f"hardware-test: {passed} passed, {failed} failed{skipped}"


def main() -> int:
    """Arguments are parts of the names of the tests to run; none means all."""
    loader = unittest.TestLoader()
    loader.testNamePatterns = [f"*{part}*" for part in sys.argv[1:]] or None
    suite = loader.discover(str(Path(__file__).parent))
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    print(summary(result))
    return 0 if result.wasSuccessful() and result.testsRun > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
