# SPDX-License-Identifier: MIT
"""The report on accuracy, and the pictures of the documents."""
