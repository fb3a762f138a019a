"""The smallest row that still shows a failure: factor after factor is set to its plain value while the failure stays."""


def shrink(row, factors, possible, fails):
    """A row in which no further factor can be plain. fails(row) -> whether it shows the failure."""
    changed = True
    while changed:
        changed = False
        for name, values in factors.items():
            plain = {**row, name: values[0]}
            if row[name] != values[0] and possible(plain) and fails(plain):
                row, changed = plain, True
    return row


def differing(row, factors):
    """What of a row is not plain."""
    return {name: value for name, value in row.items() if value != factors[name][0]}
