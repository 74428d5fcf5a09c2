"""`python -m decomplex_bt`: the command line without its console script."""

import sys

from decomplex_bt.cli.app import main

sys.exit(main())
