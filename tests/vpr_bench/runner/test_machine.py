from vpr_bench.cores import available_cores
from vpr_bench.runner.machine import describe_machine, installed


def test_describes_this_computer():
    machine = describe_machine(threads=1)
    assert machine.threads == 1
    assert 1 <= available_cores() == machine.cores
    assert machine.processor
    assert machine.libraries["numpy"] == installed("numpy")


def test_what_is_not_installed_has_no_version():
    assert installed("no-such-distribution") is None
