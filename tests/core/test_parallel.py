"""Work in several processes: the same answers, in their order; whatever ends is told."""

import os

import pytest

from nonsmooth import NoConvergence
from nonsmooth.runtime.core.parallel import in_processes

MULTIPLY = "(7).__mul__"
PID = "lambda _: __import__('os').getpid()"
END = "lambda _: __import__('os')._exit(1)"
PRINT = "lambda batch: [batch, print('no answer'), __import__('os').write(1, b'nor this')][0]"
REFUSE = "lambda batch: {}[batch]"


@pytest.mark.parametrize("workers", [1, 2, 3])
def test_answers_come_in_the_order_of_the_batches(workers):
    found = list(in_processes(eval, MULTIPLY, range(20), workers))
    assert found == [(k, 7 * k) for k in range(20)]


def test_batches_are_taken_when_they_are_needed():
    taken = []

    def batches():
        for k in range(50):
            taken.append(k)
            yield k

    for number, (batch, _) in enumerate(in_processes(eval, MULTIPLY, batches(), 2)):
        assert batch == number
        assert len(taken) <= number + 4


def test_each_process_is_another_one():
    found = {pid for _, pid in in_processes(eval, PID, range(200), 2)}
    assert len(found) == 2
    assert os.getpid() not in found
    assert {pid for _, pid in in_processes(eval, PID, range(3), 1)} == {os.getpid()}


def test_what_is_printed_is_no_answer():
    assert list(in_processes(eval, PRINT, [1, 2], 2)) == [(1, 1), (2, 2)]


def test_errors_are_those_of_the_work():
    with pytest.raises(KeyError, match="3"):
        list(in_processes(eval, REFUSE, [3], 2))


def test_a_process_that_ends_is_told():
    with pytest.raises(NoConvergence, match="for want of memory perhaps"):
        list(in_processes(eval, END, [1, 2, 3], 2))


def test_processes_end_with_whoever_asks():
    work = in_processes(eval, PID, range(100), 2)
    _, pid = next(work)
    work.close()
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)
