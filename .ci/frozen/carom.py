"""The frozen application's beginning: Carom itself, or with ``-m`` one of its modules, as Python would.

Second processes are started as ``sys.executable -m game...``; here that is this program.
"""

import runpy
import sys

sys.runs_modules = True  # type: ignore[attr-defined]  # game/app/compile/second_process.py asks

if len(sys.argv) > 2 and sys.argv[1] == "-m" and sys.argv[2].split(".")[0] == "game":
    del sys.argv[:2]
    name = sys.argv[0] + (".__main__" if sys.argv[0] == "game" else "")
    runpy.run_module(name, run_name="__main__", alter_sys=True)
else:
    from game.__main__ import main

    sys.exit(main())
