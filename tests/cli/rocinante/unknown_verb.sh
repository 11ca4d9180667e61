rocinante dance
