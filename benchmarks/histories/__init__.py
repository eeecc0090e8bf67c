"""Faults that teams fixed: is the commit before each fix told of it?"""
