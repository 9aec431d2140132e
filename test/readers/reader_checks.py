"""What the checks of our files by programs that are not ours share."""
import shutil
import subprocess
import sys


def skip(why):
    """Ends the test as one that could not be made."""
    print("skipped:", why)
    sys.exit(77)


class Checks:
    """Counts checks, and prints those that fail."""
    failures = 0
    count = 0

    def true(self, what, is_true):
        self.count += 1
        if not is_true:
            self.failures += 1
            print("wrong:", what)

    def equal(self, what, found, expected):
        self.true(f"{what}: {found!s:.300} instead of {expected!s:.300}", found == expected)

    def finish(self, program):
        """Ends the test."""
        print(f"{program}: {self.count} checks, {self.failures} failures")
        sys.exit(self.failures > 0 or not self.count)


def node_package(folder, package):
    """Has npm bring a package into the folder; returns the path of node."""
    npm, node = shutil.which("npm"), shutil.which("node")
    if not npm or not node:
        skip(f"npm or node is not installed, which {package} needs")
    if not (folder / "node_modules" / package.split("@")[0]).is_dir():
        folder.mkdir(exist_ok=True)
        run = subprocess.run([npm, "install", "--no-audit", "--no-fund", "--prefix", str(folder), package],
                             capture_output=True, text=True, cwd=folder)
        if run.returncode:
            skip(f"npm cannot get {package}: {run.stderr.strip().splitlines()[-1:]}")
    return node
