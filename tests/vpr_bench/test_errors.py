import pytest

from vpr_bench.errors import DataError, UsageError, VprBenchError, closest


@pytest.mark.parametrize(("kind", "code"), [(VprBenchError, 1), (UsageError, 2), (DataError, 3)])
def test_each_kind_of_error_has_its_exit_code(kind, code):
    assert kind("what").exit_code == code
    assert issubclass(kind, VprBenchError)


def test_the_nearest_name_is_suggested():
    assert closest("garden", ["nordland", "gardens"]) == "Did you mean 'gardens'?"


def test_all_names_are_listed_in_order_when_none_is_near():
    assert closest("xyz", ["nordland", "gardens"]) == "Known: gardens, nordland."
    assert closest("xyz", []) == "Known: none."
