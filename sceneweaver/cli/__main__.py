"""``python -m sceneweaver.cli``: the command line."""

import sys

from sceneweaver.cli import main

if __name__ == "__main__":
    sys.exit(main())
