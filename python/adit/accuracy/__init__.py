"""Computes a scene as accurately as is asked, and tells the interval in which the results lie."""
