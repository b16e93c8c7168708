"""What accuracy costs in time: studies, references, reports."""

from game.lab.analysis import (
    cost_to_reach,
    fit_exponent,
    fit_order,
    fitted,
    out_of_order,
    settled,
    slope_of,
    summarise,
    upper_envelope,
)
from game.lab.picture import PlotsMissingError
from game.lab.report import write_report
from game.lab.runner import StoppedError, measure, measure_present, run_study
from game.lab.study import (
    ACCURACY,
    Axes,
    Knob,
    Method,
    Outcome,
    Row,
    Setting,
    Study,
    StudyTable,
    Trial,
    Workload,
)

__all__ = [
    "ACCURACY",
    "Axes",
    "Knob",
    "Method",
    "Outcome",
    "PlotsMissingError",
    "Row",
    "Setting",
    "StoppedError",
    "Study",
    "StudyTable",
    "Trial",
    "Workload",
    "cost_to_reach",
    "fit_exponent",
    "fit_order",
    "fitted",
    "measure",
    "measure_present",
    "out_of_order",
    "run_study",
    "settled",
    "slope_of",
    "summarise",
    "upper_envelope",
    "write_report",
]
