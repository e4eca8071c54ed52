"""`python -m candela`: what candela finds on this machine. The exit status is 0 where it can draw."""

import json
import sys

from candela.diagnosis import diagnose, probe


def main() -> int:
    if sys.argv[1:] == ["--probe"]:
        print(json.dumps(probe()))
        return 0
    if len(sys.argv) > 1:
        print(__doc__)
        return 0 if sys.argv[1] in ("-h", "--help") else 2
    return 0 if diagnose().works else 1


if __name__ == "__main__":
    sys.exit(main())
