"""The coupled variants that no other variant beats in both cost and error, and the advice that follows."""

ALONE = "particles only"  # the family without coupling, with which only costs are compared
TARGETS = (0.01, 0.02, 0.05, 0.1)
UNITS = {"cpu_s": "CPU s", "updates": "updates"}


def coupled(rows):
    return [row for row in rows if row["family"] != ALONE]


def front(rows, error, cost):
    """Coupled rows in the order of their cost, each with a smaller error than all that cost less."""
    best, smallest = [], float("inf")
    for row in sorted(coupled(rows), key=lambda row: (row[cost], row[error])):
        if row[error] < smallest:
            best.append(row)
            smallest = row[error]
    return best


def advice(rows):
    """Lines with the cheapest variant that keeps each of the three histories within an error, and the particles' cost."""
    for row in rows:
        if row["family"] == ALONE:
            yield f"{row['variant']}: " + ", ".join(f"{row[cost]:.3g} {unit}" for cost, unit in UNITS.items())
    for target in TARGETS:
        good = [row for row in coupled(rows) if max(row["force_l2"], row["near_l2"], row["far_l2"]) <= target]
        cheapest = {cost: min(good, key=lambda row: row[cost]) for cost in UNITS if good}
        yield f"coupled, within {100 * target:g} %: " + (
            "; ".join(f"{row['variant']} ({row[cost]:.3g} {UNITS[cost]})" for cost, row in cheapest.items())
            or "none of them")
