"""Write the accounts of scenes, of those named or of all: `python -m tests.golden [SCENE ...]`.

Digests are written by `python -m game selftest --update-golden`, what the window shows on a tour by
`python -m tests.golden.window`.
"""

from __future__ import annotations

import argparse
import os
import tempfile

from game.app.stagehand.headless import prepare
from game.scenes import CATALOGUE
from tests.golden import kept
from tests.golden.accounts import account_of


def main() -> None:
    """Read the command line and write."""
    parser = argparse.ArgumentParser(prog="python -m tests.golden", description=__doc__)
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    options = parser.parse_args()
    os.environ.setdefault("CAROM_HOME", tempfile.mkdtemp(prefix="carom-home-"))
    prepare()
    for name in options.scenes or [entry.name for entry in CATALOGUE]:
        account = account_of(name)
        before = kept.read(name) if kept.file_of(name).exists() else {}
        changed = list(kept.differences(before, account))
        kept.write(name, account)
        print(f"{name}: {len(changed)} lines changed", *changed[:5], sep="\n  ", flush=True)


if __name__ == "__main__":
    main()
