import pytest

from vpr_bench.cores import available_cores
from vpr_bench.runner.machine import Machine, _from_cpuinfo, _from_sysctl, describe_machine, installed

OLD = {"system": "Linux-6.1", "processor": "A", "cores": 4, "threads": 2, "python": "3.11.7", "libraries": {}}


def test_describes_this_computer():
    machine = describe_machine(threads=1)
    assert machine.threads == 1
    assert 1 <= available_cores() == machine.cores
    assert machine.processor
    assert machine.memory_bytes > 2**28
    assert machine.blas and all(line.strip() for line in machine.blas)
    assert machine.libraries["numpy"] == installed("numpy")
    assert machine.libraries["vpr-bench"] == installed("vpr-bench")


def test_tools_of_development_are_not_noted():
    assert not {"pytest", "ruff", "mypy", "hypothesis"} & describe_machine(threads=1).libraries.keys()


def test_what_is_not_installed_has_no_version():
    assert installed("no-such-distribution") is None


def test_one_of_an_older_version():
    machine = Machine.model_validate(OLD)
    assert machine.memory_bytes is None and machine.blas is None
    assert str(machine) == "A, 4 cores, 2 threads, Linux"
    assert len(machine.fingerprint) == 8


@pytest.mark.parametrize(
    ("change", "same"),
    [
        ({"libraries": {"numpy": "9"}}, True),
        ({"python": "3.12.0"}, True),
        ({"system": "Linux-6.2"}, True),
        ({"blas": ["openblas 1"]}, True),
        ({"processor": "B"}, False),
        ({"cores": 8}, False),
        ({"threads": 1}, False),
        ({"memory_bytes": 2**34}, False),
        ({"system": "Windows-11"}, False),
    ],
)
def test_times_may_be_compared_on_the_same_hardware(change, same):
    found = Machine.model_validate(OLD | change).fingerprint == Machine.model_validate(OLD).fingerprint
    assert found is same


def test_memory_is_taken_to_the_gib():
    one, other = (Machine.model_validate(OLD | {"memory_bytes": size}) for size in (2**34, 2**34 + 10**6))
    assert one.fingerprint == other.fingerprint
    assert "16 GiB" in str(one)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("processor\t: 0\nmodel name\t: Fast (TM) 9\n\nprocessor\t: 1\nmodel name\t: Slow 1\n", "Fast (TM) 9"),
        ("processor : 0\nCPU implementer\t: 0x41\nCPU part\t: 0xd0c\n", "aarch64 0x41 0xd0c"),
        ("processor : 0\n", ""),
    ],
)
def test_a_processor_by_its_name_or_by_its_numbers(monkeypatch, text, name):
    monkeypatch.setattr("platform.machine", lambda: "aarch64")
    assert _from_cpuinfo(text) == name


def test_without_sysctl_it_says_nothing(monkeypatch):
    monkeypatch.setattr("shutil.which", lambda name: None)
    assert _from_sysctl() == ""
