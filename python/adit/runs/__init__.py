"""Runs: of one scene, of a case, of variants; and watching one."""
