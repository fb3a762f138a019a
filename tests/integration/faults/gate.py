"""A network through which nothing comes for some time, while no end hears of it."""

import threading


class Gate:
    """Shut by the twentieth frame of a kind; opens again after some seconds, or never."""

    def __init__(self, test, kind, seconds=None):
        self.kind, self.seconds, self.count = kind, seconds, 0
        self.open = threading.Event()
        self.open.set()
        test.addCleanup(self.open.set)

    def carry(self, kind, data):
        self.count += kind == self.kind
        if kind == self.kind and self.count == 20:
            self.open.clear()
            if self.seconds is not None:
                threading.Timer(self.seconds, self.open.set).start()
        self.open.wait()
        yield data
