"""Prints the versions of packages, a line each: the receipts of the manifest. Usage: version.py NAME.."""

import sys
from importlib.metadata import version

for name in sys.argv[1:]:
    print(name, version(name))
