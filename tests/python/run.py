#!/usr/bin/env python3
"""Runs the tests of the Python module that lie beside this file: run.py SOURCE COMMAND.

Exit status 77: pytest is not there. PYTHONPATH says where the module is.
"""
import os
import pathlib
import sys



def main():
    try:
        import pytest
    except ImportError as missing:
        print(f"SKIPPED: {missing}; tools/setup installs python3-pytest", flush=True)
        return 77
    os.environ["TESTED_SOURCE"], os.environ["TESTED_COMMAND"], *arguments = sys.argv[1:]
    here = str(pathlib.Path(__file__).parent)
    return pytest.main(["-q", "-p", "no:cacheprovider", "-o", "python_files=*_test.py", "--rootdir", here,
                        *(arguments or [here])])


if __name__ == "__main__":  # processes that tests spawn import this file
    sys.exit(main())
