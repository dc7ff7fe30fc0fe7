"""How much memory a process has needed."""

from pathlib import Path

import psutil


def peak_rss_bytes() -> int:
    """Return the most memory this process has held.

    Linux and Windows tell it; elsewhere it is what the process holds now.
    """
    status = Path("/proc/self/status")
    if status.exists():
        for line in status.read_text().splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024
    memory = psutil.Process().memory_info()
    return int(getattr(memory, "peak_wset", memory.rss))
