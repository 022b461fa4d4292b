"""Says what a run of ctest proved: how many tests passed, and which did not run and why.

usage: ctest_verdict.py JUNIT_FILE       what `ctest --output-junit` wrote
Prints one line for each test that did not run, then the summary as the last line. Exits 1 when a test failed or none
passed: ctest itself counts a skipped test as passed, and an empty run too.
"""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

DATA_REMEDY = "set TRIPOINT_SHARED"  # how a test ends its reason when pictures or measurements of others are absent
REASON = re.compile(r":\d+: Skipped\n(.+)")  # GoogleTest's place of the skip, and the words on the next line


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of one test."""

    name: str
    passed: bool
    skipped_because: str | None  # None: it ran


def outcomes(junit: str) -> list[Outcome]:
    return [_outcome(case) for case in ElementTree.fromstring(junit).iter("testcase")]


def _outcome(case: ElementTree.Element) -> Outcome:
    name, status = case.get("name", ""), case.get("status", "")
    skipped = case.find("skipped")
    if status == "disabled":
        return Outcome(name, passed=False, skipped_because="disabled")
    if status == "notrun" and skipped is not None and skipped.get("message") == "SKIP_REGULAR_EXPRESSION_MATCHED":
        reason = REASON.search(case.findtext("system-out") or "")
        return Outcome(name, passed=False, skipped_because=reason[1] if reason else "it gave no reason")
    return Outcome(name, passed=status == "run", skipped_because=None)


def summary(found: list[Outcome]) -> str:
    passed = sum(one.passed for one in found)
    reasons = [one.skipped_because for one in found if one.skipped_because is not None]
    failed = len(found) - passed - len(reasons)
    words = f"{passed} tests passed, {failed} failed, {len(reasons)} skipped"
    without_data = sum(reason.endswith(DATA_REMEDY) for reason in reasons)
    if without_data > 0:
        words += f"; nothing was proved on the data that {without_data} of these lack: {DATA_REMEDY}"
    return words


def sound(found: list[Outcome]) -> bool:
    return any(one.passed for one in found) and all(one.passed or one.skipped_because is not None for one in found)


def main() -> int:
    found = outcomes(Path(sys.argv[1]).read_text(encoding="utf-8"))
    for one in found:
        if one.skipped_because is not None:
            print(f"skipped: {one.name}: {one.skipped_because}")
    print(summary(found))
    return 0 if sound(found) else 1


if __name__ == "__main__":
    sys.exit(main())
