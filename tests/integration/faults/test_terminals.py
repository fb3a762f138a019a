"""A terminal that is closed ends its run as SIGHUP does, with a checkpoint from which it goes on. A run that has left the terminal,
or ignores SIGHUP, does not notice."""

import fcntl
import os
import pty
import shutil
import signal
import termios
import time
import unittest

from faults.faulty import FaultTest


def take_terminal():
    os.setsid()
    fcntl.ioctl(0, termios.TIOCSCTTY, 0)
    signal.signal(signal.SIGHUP, signal.SIG_DFL)


def take_terminal_by_nohup():
    take_terminal()
    signal.signal(signal.SIGHUP, signal.SIG_IGN)


class Terminals(FaultTest):
    def closed(self, begin):
        """A run at a terminal of its own, which is closed in mid-run."""
        ours, theirs = pty.openpty()
        run = self.started(stdin=theirs, stdout=theirs, stderr=theirs, preexec_fn=begin)
        os.close(theirs)
        os.close(ours)
        return run

    def test_a_closed_terminal(self):
        run = self.closed(take_terminal)
        self.assertEqual(run.wait(20), 128 + signal.SIGHUP)
        self.assert_unfinished("ended by SIGHUP", more_than=5)
        self.assertTrue(any((self.folder / "run/checkpoints").glob("*/checkpoint.json")))

    def test_runs_that_a_closed_terminal_leaves_alone(self):
        for begin in (take_terminal_by_nohup, os.setsid):
            shutil.rmtree(self.folder / "run", ignore_errors=True)
            run = self.closed(begin)
            size = (self.folder / "run/histories.csv").stat().st_size
            time.sleep(0.5)
            self.assertIsNone(run.poll())
            self.assertGreater((self.folder / "run/histories.csv").stat().st_size, size)
            run.kill()
            run.wait()


if __name__ == "__main__":
    unittest.main()
