from __future__ import annotations

import subprocess
import sys
from itertools import islice
from pathlib import Path
from time import sleep

import pytest
from joblib import delayed

from decomplex_bt.processes import results

STOPS = """
from joblib import delayed
from decomplex_bt.processes import results

if __name__ == "__main__":
    found = results((delayed(abs)(-k) for k in range(1000)), 2)
    print(next(found))
    found.close()
"""


@pytest.mark.parametrize("jobs", [1, 2])
def test_results_come_in_the_order_of_the_calls(jobs) -> None:
    assert list(results((delayed(abs)(-k) for k in range(20)), jobs)) == list(range(20))


@pytest.mark.parametrize("jobs", [1, 2])
def test_caller_that_has_seen_enough_ends_the_calls(jobs) -> None:
    taken = []

    def calls():
        for k in range(1000):
            taken.append(k)
            yield delayed(sleep)(0.02)

    found = results(calls(), jobs)
    assert list(islice(found, 3)) == [None, None, None]
    found.close()
    assert len(taken) < 500  # far from all, however late a busy machine comes to closing
    assert list(results([delayed(abs)(-7)], jobs)) == [7]  # the processes are there for the next


@pytest.mark.parametrize("jobs", [1, 2])
def test_error_of_a_call_reaches_the_caller(jobs) -> None:
    with pytest.raises(ValueError, match="invalid literal"):
        list(results((delayed(int)(text) for text in ("1", "x", "2")), jobs))


@pytest.mark.parametrize("jobs", [1, 2])
def test_error_of_a_call_that_nobody_waits_for_is_no_error(jobs) -> None:
    found = results((delayed(lambda k: sleep(k) or 1 // (1 - k))(k) for k in (0, 0, 0, 1)), jobs)
    assert next(found) == 1
    found.close()


def test_process_that_stops_early_says_nothing(tmp_path: Path) -> None:
    script = tmp_path / "stops.py"
    script.write_text(STOPS, encoding="utf-8")
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "0\n", "")
