"""The command `adit` where no launcher is installed: python3 -m adit, or python3 FOLDER/adit."""
import sys
from pathlib import Path

if not __package__:  # started by the path of the folder, whose modules would hide others of the same names
    sys.path[0] = str(Path(__file__).resolve().parents[1])

from adit.cli import main  # noqa: E402

main()
