// errors.m

#import "errors.h"
#include <string.h>

NSError *
error_saying(enum status status, NSString *format, ...)
{
  va_list values;

  va_start(values, format);
  NSString *text = [[NSString alloc] initWithFormat: format
                                          arguments: values];
  va_end(values);
  NSDictionary *info =
    [NSDictionary dictionaryWithObject: text
                                forKey: NSLocalizedDescriptionKey];
  [text release];
  return [NSError errorWithDomain: @"raytrace" code: status userInfo: info];
}

NSString *
error_text(NSError *error)
{
  NSString *text = [[error userInfo] objectForKey: NSLocalizedDescriptionKey];

  if (text == nil && [[error domain] isEqual: NSPOSIXErrorDomain])
    {
      text = [NSString stringWithUTF8String: strerror((int)[error code])];
    }
  return text ? text : [error localizedDescription];
}
