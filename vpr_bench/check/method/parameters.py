"""What a method is made of."""

import json
from typing import Any

from vpr_bench.check.method.subject import Subject
from vpr_bench.check.outcome import Failed, Skipped
from vpr_bench.check.suite import check
from vpr_bench.method.build import build_method


@check("declares-parameters")
def declares_parameters(subject: Subject) -> None:
    """Check that what stands in a result about the parameters makes the same method again."""
    built = subject.build()
    if built is None or subject.name is None:
        subject.make()
        raise Skipped("it is made by a function: name its class to have its parameters checked")
    read = json.loads(json.dumps(built.parameters))
    again = build_method(subject.name, read).parameters
    for name, value in built.parameters.items():
        if again[name] != value:
            raise Failed(f"the parameter {name} is {value!r}, but {again[name]!r} after it was read from a result")
        kept = getattr(built.method, name, value)
        if not _is_method(value) and kept != value:
            raise Failed(f"the constructor makes {name}={kept!r} of {name}={value!r}, which is what results say")


def _is_method(value: Any) -> bool:
    return isinstance(value, dict) and "method" in value


CHECKS = (declares_parameters,)
