# SPDX-License-Identifier: MIT
"""The report on accuracy, and the pictures of the documents.

The report on accuracy, for `fixel report`; pictures that are compared or drawn, for `fixel compare`, `wire`, `pictures`, `showcase`
and `first-program`. The command has the module of its name; `accuracy.py`, `comparison.py`, `wireframes.py`,
`picture_row.py`, `examples.py` and `looks.py` do its work. `report_claims.py` and `report_stages.py` measure,
`report_averages.py` compares with the record of averages, `report_plots.py` draws, and `report_page.py` writes the page. `compare.mk` gives `make compare` its exit codes.

The other side of a claim is `host_tests/judges/oracle`: its program draws the samples and judges them exactly. What
measures the stages is `host_tests/stages`.
"""
