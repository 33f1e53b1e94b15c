"""What relations and rules mean, as data, read by engine, judge, reader and critic; none of them has its own numbers.

The lowest floor. Metres, degrees.
"""
