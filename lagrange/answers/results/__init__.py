"""Wrong results other than equations of motion: which changed problem do they solve?"""
