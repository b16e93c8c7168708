"""The accuracy report: what all scenes' studies measured, and what every effect costs, on one page."""
