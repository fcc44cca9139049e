# SPDX-License-Identifier: MIT
"""The report on accuracy, and the pictures of the documents.

The commands `fixel report`, `compare`, `wire`, `pictures`, `showcase` and `first-program` have the modules of their names;
`examples.py` has what `first-program` draws. `report_claims.py` and `report_frames.py` measure, `report_plots.py` draws, and
`report_page.py` writes the page. `compare.mk` gives `make compare` its exit codes.

The other side of a claim is `host_tests/judges/oracle`: its program draws the samples and judges them exactly. What measures
the stages is `host_tests/stages`.
"""
