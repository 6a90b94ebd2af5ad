"""Readers of GRMHD codes' files, and what makes a grid of matter of them: scripts/convert_grmhd.py."""
