"""The variants that no other one beats, and what they advise."""

TARGETS = (0.005, 0.01, 0.02, 0.05, 0.1)


def front(rows, error, cost):
    """Rows by rising cost, each with a smaller error than all that cost less."""
    best, smallest = [], float("inf")
    for row in sorted(rows, key=lambda row: (row[cost], row[error])):
        if row[error] < smallest:
            best.append(row)
            smallest = row[error]
    return best


def advice(rows):
    """Lines: what costs least to stay within each error."""
    for target in TARGETS:
        good = [row for row in rows if max(row["force_l2"], row["near_l2"], row["far_l2"]) <= target]
        if not good:
            yield f"within {100 * target:g} %: none of them"
            continue
        yield f"within {100 * target:g} %: " + "; ".join(
            f"{cheapest['variant']} ({cheapest[cost]:.3g} {unit})"
            for cost, unit in (("cpu_s", "CPU s"), ("updates", "updates"))
            for cheapest in [min(good, key=lambda row: row[cost])])
