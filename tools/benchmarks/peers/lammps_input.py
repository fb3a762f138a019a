"""Computes an input of LAMMPS by its library, as the program `lmp` does, and then the commands of the standard input, of which it
prints the seconds that they take: lammps_input.py FILE."""
import ctypes
import sys
import time

library = ctypes.CDLL("liblammps.so.0", ctypes.RTLD_GLOBAL)
library.lammps_open_no_mpi.restype = ctypes.c_void_p
words = (ctypes.c_char_p * 3)(b"lammps", b"-log", b"none")
lammps = ctypes.c_void_p(library.lammps_open_no_mpi(len(words), words, None))
library.lammps_file(lammps, sys.argv[1].encode())
for command in sys.stdin:
    begin = time.perf_counter()
    library.lammps_command(lammps, command.encode())
    print("seconds", time.perf_counter() - begin, flush=True)
