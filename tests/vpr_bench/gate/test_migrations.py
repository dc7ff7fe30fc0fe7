from vpr_bench.gate import migrations
from vpr_bench.gate.migrations import migrated


def test_the_present_schema_is_left_as_it_is():
    content = {"schema_version": migrations.SCHEMA_VERSION, "cells": {}}
    assert migrated(content) == content


def test_former_schemas_go_step_by_step(monkeypatch):
    monkeypatch.setattr(migrations, "SCHEMA_VERSION", 3)
    steps = {1: lambda old: {**old, "one": True}, 2: lambda old: {**old, "two": old["one"]}}
    monkeypatch.setattr(migrations, "_STEPS", steps)
    assert migrated({"schema_version": 1}) == {"schema_version": 3, "one": True, "two": True}
