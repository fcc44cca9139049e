# SPDX-License-Identifier: MIT
"""Campaigns: commands whose work is numbered shards, run by processes of this machine or of a cluster."""
