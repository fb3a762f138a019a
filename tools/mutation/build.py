"""A scratch copy of the project with a build of its own, in which one file at a time is changed."""

import hashlib
import os
import pathlib
import shutil
import subprocess


def sources_of(root):
    """Paths of the project's files, those not yet committed included; where there is no clone, all that are not built."""
    asked = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=root, capture_output=True, text=True)
    listed = asked.stdout.split("\0") if asked.returncode == 0 else (
        path.relative_to(root).as_posix() for path in root.rglob("*") if path.relative_to(root).parts[0] not in ("build", "runs"))
    return sorted({path for path in listed if path and (root / path).is_file()})


class Build:
    """`folder`/source is the copy, and what changes between two runs is all that is copied and built again."""

    def __init__(self, root, folder, preset="release", cores=1):
        self.source = folder / "source"
        self.binary = self.source / "build" / preset
        self._cores, self._preset = cores, preset
        self._environment = {**os.environ, "CCACHE_BASEDIR": str(self.source), "CCACHE_NOHASHDIR": "1"}
        if shutil.which("ccache"):
            self._environment["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
        self._copy(root)

    def _copy(self, root):
        paths = sources_of(root)
        self.source.mkdir(parents=True, exist_ok=True)
        if not (self.source / ".git").exists():  # of its own: what lies in the user's build folder is ignored there
            subprocess.run(["git", "init", "-q"], cwd=self.source, check=True)
        for path in set(sources_of(self.source)) - set(paths):
            (self.source / path).unlink()
        for path in paths:
            target = self.source / path
            if target.exists() and target.read_bytes() == (root / path).read_bytes():
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(root / path, target)

    def configure(self):
        self._run(["cmake", "--preset", self._preset, "-DCMAKE_UNITY_BUILD=OFF"], self.source).check_returncode()

    def make(self, *targets):
        """Whether they could be built."""
        if not targets:
            return True
        return self._run(["ninja", "-C", self.binary, f"-j{self._cores}", *targets], self.source).returncode == 0

    def _run(self, command, folder):
        return subprocess.run([str(part) for part in command], cwd=folder, env=self._environment, capture_output=True,
                              text=True)

    def _ask(self, *question):
        answer = self._run(["ninja", "-C", self.binary, "-t", *question], self.source)
        answer.check_returncode()
        return answer.stdout.splitlines()

    def executables(self):
        """Targets that are programs."""
        rules = (line.partition(": ") for line in self._ask("targets", "all"))
        return [name for name, _, rule in rules if rule.startswith("CXX_EXECUTABLE_LINKER")]

    def inputs(self, target):
        """Files of the project that the target is made of, headers excepted: paths from its root."""
        inside = (os.path.relpath(line, self.source) for line in self._ask("inputs", target) if line.startswith("/"))
        return {path for path in inside if not path.startswith((".", "build"))}

    def started_by(self, target, executables):
        """Those that are built with a test program because it starts them, and the program itself."""
        return [target, *sorted(set(self._ask("inputs", target)) & set(executables) - {target})]

    def objects(self):
        """Objects that were made of each file: of a source file one, of a header all that include it."""
        users, current = {}, None
        for line in self._ask("deps"):
            if line and not line.startswith(" "):
                current = line.partition(": #deps")[0]
            elif line:
                path = os.path.normpath(self.binary / line.strip())
                if path.startswith(str(self.source)):
                    users.setdefault(os.path.relpath(path, self.source), []).append(current)
        return users

    def fingerprint(self, target):
        path = self.binary / target
        return hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else None

    def apply(self, change):
        """Changes the line; returns what undoes it."""
        path = pathlib.Path(self.source / change.path)
        text = path.read_text()
        lines = text.splitlines(keepends=True)
        assert lines[change.line - 1].rstrip("\n") == change.before, f"{change.path}:{change.line} is another line now"
        lines[change.line - 1] = change.after + "\n"
        path.write_text("".join(lines))
        return lambda: path.write_text(text)
