"""What the page says of the worst places in detail: the joint by the beam and by its unified section."""
from adit.cases.tunnels import plan_joint
from adit.report.markup import bullets, table
from adit.report.quantities import quantity, unit_of
from adit.study import detail


def told(outcome):
    """A table for each run, and a sentence for each that failed."""
    study = outcome.study
    tables = [table(f"{detail.name_of(study, row)}: largest values of {row['joint']} at {row['chainage_m']:g} m",
                    ("", "beam", "unified section", "difference"), [values(row, column) for column in plan_joint.COLUMNS.values()])
              for row in outcome.closer if not row["failed"]]
    failed = [f"{detail.name_of(study, row)} could not be computed in detail: {row['failed']}" for row in outcome.closer if row["failed"]]
    return [*tables, bullets(failed)]


def values(row, column):
    by_beam, by_section = (row[f"{model}_{column}"] for model in detail.MODELS)
    return (detail.said(column), quantity(by_beam, unit_of(column)), quantity(by_section, unit_of(column)),
            detail.difference(by_beam, by_section).replace("-", "−"))
