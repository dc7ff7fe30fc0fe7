import pytest

from vpr_bench.files.migrations import migrated

STEPS = {1: lambda old: {**old, "one": True}, 2: lambda old: {**old, "two": old["one"]}}


def test_the_present_schema_is_left_as_it_is():
    content = {"schema_version": 3, "cells": {}}
    assert migrated(content, STEPS, 3) == content


@pytest.mark.parametrize(
    ("found", "expected"), [({}, {"one": True, "two": True}), ({"schema_version": 2, "one": 0}, {"one": 0, "two": 0})]
)
def test_former_schemas_go_step_by_step(found, expected):
    content = {"schema_version": 1} | found
    before = dict(content)
    assert migrated(content, STEPS, 3) == {"schema_version": 3} | expected
    assert content == before
