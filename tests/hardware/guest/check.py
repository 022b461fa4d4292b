"""Runs every test of this folder and prints one line that says how it went."""

import sys
import time
import unittest
from pathlib import Path


class TimedResult(unittest.TextTestResult):
    """Says after each test how long it took; a test with several failed sub-tests counts as one."""

    def startTest(self, test: unittest.TestCase) -> None:
        self.began = time.monotonic()
        super().startTest(test)

    def stopTest(self, test: unittest.TestCase) -> None:
        self.stream.writeln(f"  took {time.monotonic() - self.began:.1f} s")
        super().stopTest(test)

    def failed_tests(self) -> int:
        tests = (test for test, _ in (*self.failures, *self.errors))
        return len({getattr(test, "test_case", test).id() for test in tests})


def main() -> int:
    suite = unittest.defaultTestLoader.discover(str(Path(__file__).parent))
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2, resultclass=TimedResult).run(suite)
    failed = result.failed_tests()
    print(f"hardware-test: {result.testsRun - failed - len(result.skipped)} passed, {failed} failed"
          + (f", {len(result.skipped)} skipped" if result.skipped else ""))
    return 0 if result.wasSuccessful() and result.testsRun > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
