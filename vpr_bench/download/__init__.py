"""Getting files from the internet into a folder, so that what arrives is whole and is what was asked for.

Most callers need :func:`fetch_archive` or :func:`fetch_file`: they lock, download, verify and put in place.
The steps are there on their own too: :func:`download`, :func:`extract_archive`, :func:`check_digest`.
Importing this package is cheap: what speaks HTTP is imported when a download starts.
"""

from vpr_bench.download.archive import extract_archive
from vpr_bench.download.fetch import fetch_archive, fetch_file
from vpr_bench.download.http import download
from vpr_bench.download.members import Limits
from vpr_bench.files.digest import check_digest, parse_digest, sha256_of_file
from vpr_bench.files.disk import DiskError

__all__ = [
    "DiskError",
    "Limits",
    "check_digest",
    "download",
    "extract_archive",
    "fetch_archive",
    "fetch_file",
    "parse_digest",
    "sha256_of_file",
]
