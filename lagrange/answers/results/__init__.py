"""Wrong results that are no equations of motion: of which changed problem are they?"""
