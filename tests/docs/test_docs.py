"""Every code block of README and docs runs as it is printed."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
BLOCK = re.compile(r"^```(python|console)\n(.*?)^```", re.MULTILINE | re.DOTALL)


def blocks():
    for page in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        for number, found in enumerate(BLOCK.finditer(page.read_text("utf-8"))):
            yield pytest.param(page.stem, found[1], found[2], id=f"{page.name}-{number}")


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """Return a folder for each page, in which its blocks run one after the other."""
    return tmp_path_factory.mktemp("docs")


@pytest.mark.parametrize(("page", "language", "code"), list(blocks()))
def test_block(page, language, code, folders):
    folder = folders / page
    folder.mkdir(exist_ok=True)
    if language == "console" and shutil.which("bash") is None:
        pytest.skip("these are commands for a POSIX shell, and there is no bash here")
    scripts = Path(sys.executable).parent
    environment = {**os.environ, "PATH": f"{scripts}{os.pathsep}{os.environ['PATH']}"}
    command = [sys.executable, "-c", code] if language == "python" else ["bash", "-euo", "pipefail", "-c", code]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
